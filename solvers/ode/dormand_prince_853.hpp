#pragma once

#include <cmath>
#include <string_view>

#include "solvers/ode/controlled.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/tableau.hpp"

namespace oddity::ode {

/// Dormand and Prince's order 8 with Hairer's embedded orders 5 and 3 for the step control, twelve
/// evaluations per step. Stable to h |lambda| = 6.394 on the negative real axis and 5.960 on the imaginary
/// axis. Its coefficients are those of E. Hairer's program DOP853: Hairer, Norsett and Wanner, Solving
/// Ordinary Differential Equations I, 2nd edition, 1993, section II.10.
///
/// The error is that of the embedded order 5, e5, times |e5| / sqrt(e5^2 + 0.01 e3^2), whose norms are over
/// all unknowns. So it shrinks as h^8. Hairer's program takes the mean square of the errors; Odeint's step
/// control takes the largest.
struct DormandPrince853 {
  static constexpr std::string_view name = "DOP853";
  static constexpr Kind kind = Kind::controlled;
  static constexpr int order = 8;
  static constexpr Facts facts{.library = Facts::own,
                               .evaluations = 12,
                               .real_limit = 6.393652,
                               .imaginary_limit = 5.960360,
                               .theory = Facts::polynomial};

  struct Tableau {
    static constexpr int order = DormandPrince853::order;
    using Weights = detail::Weights<12>;
    static constexpr Weights c = {0,
                                  0.0526001519587677318785587544488,
                                  0.0789002279381515978178381316732,
                                  0.11835034190722739672675719751,
                                  0.28164965809277260327324280249,
                                  0.333333333333333333333333333333,
                                  0.25,
                                  0.307692307692307692307692307692,
                                  0.651282051282051282051282051282,
                                  0.6,
                                  0.857142857142857142857142857142,
                                  1};
    static constexpr Weights a[] = {
        {},
        {0.0526001519587677318785587544488},
        {0.0197250569845378994544595329183, 0.0591751709536136983633785987549},
        {0.0295875854768068491816892993775, 0, 0.0887627564304205475450678981324},
        {0.241365134159266685502369798665, 0, -0.884549479328286085344864962717,
         0.924834003261792003115737966543},
        {0.037037037037037037037037037037, 0, 0, 0.170828608729473871279604482173,
         0.125467687566822425016691814123},
        {0.037109375, 0, 0, 0.170252211019544039314978060272, 0.0602165389804559606850219397283,
         -0.017578125},
        {0.0370920001185047927108779319836, 0, 0, 0.170383925712239993810214054705,
         0.107262030446373284651809199168, -0.0153194377486244017527936158236,
         0.00827378916381402288758473766002},
        {0.624110958716075717114429577812, 0, 0, -3.36089262944694129406857109825,
         -0.868219346841726006818189891453, 27.5920996994467083049415600797, 20.1540675504778934086186788979,
         -43.4898841810699588477366255144},
        {0.477662536438264365890433908527, 0, 0, -2.48811461997166764192642586468,
         -0.590290826836842996371446475743, 21.2300514481811942347288949897, 15.2792336328824235832596922938,
         -33.2882109689848629194453265587, -0.0203312017085086261358222928593},
        {-0.93714243008598732571704021658, 0, 0, 5.18637242884406370830023853209,
         1.09143734899672957818500254654, -8.14978701074692612513997267357, -18.5200656599969598641566180701,
         22.7394870993505042818970056734, 2.49360555267965238987089396762, -3.0467644718982195003823669022},
        {2.27331014751653820792359768449, 0, 0, -10.5344954667372501984066689879,
         -2.00087205822486249909675718444, -17.9589318631187989172765950534, 27.9488845294199600508499808837,
         -2.85899827713502369474065508674, -8.87285693353062954433549289258, 12.3605671757943030647266201528,
         0.643392746015763530355970484046}};
    static constexpr Weights b = {0.0542937341165687622380535766363,
                                  0,
                                  0,
                                  0,
                                  0,
                                  4.45031289275240888144113950566,
                                  1.89151789931450038304281599044,
                                  -5.8012039600105847814672114227,
                                  0.31116436695781989440891606237,
                                  -0.152160949662516078556178806805,
                                  0.201365400804030348374776537501,
                                  0.0447106157277725905176885569043};
    static constexpr Weights third_order = {
        0.244094488188976377952755905512, 0, 0, 0, 0, 0, 0, 0, 0.733846688281611857341361741547, 0, 0,
        0.0220588235294117647058823529412};
    static constexpr Weights estimates[] = {
        {0.01312004499419488073250102996, 0, 0, 0, 0, -1.225156446376204440720569753,
         -0.4957589496572501915214079952, 1.664377182454986536961530415, -0.350328848749973681688648729,
         0.3341791187130174790297318841, 0.08192320648511571246570742613, -0.02235530786388629525884427845},
        detail::difference(b, third_order)};

    /// Takes all of e5 where squares overflow or vanish.
    static double part(double e5_squared, double e3_squared) {
      if (!(e5_squared > 0 && e3_squared < Facts::everywhere)) return 1;
      return 1 / std::sqrt(1 + 0.01 * e3_squared / e5_squared);
    }
  };

  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  /// The method without its step control.
  template <class State>
  using Plain = detail::EmbeddedRungeKutta<Tableau, State>;
  template <class State>
  static auto stepper(double tolerance) {
    return detail::controlled<Plain<State>>(tolerance);
  }
};

}  // namespace oddity::ode
