// Exercise 2.5: the angular velocity of a rotation by theta(t) about a unit axis D(t),
//   w = theta' D + sin(theta) D' + (1 - cos(theta)) D x D'        (Skew(w) = R' R^T)
// The other route never meets Rodrigues' formula: R is the matrix of the unit quaternion
// (cos(theta/2), sin(theta/2) D), derivatives are dual numbers, and w is the vector part of 2 q' q*
// [Kuipers, Quaternions and Rotation Sequences, 11.4]. Every line of the proof is held against these numbers,
// on motions with |D'| = 1, which the proof takes for granted, and with any |D'|.
//   U1 = D, U2 = D', U3 = D x D', S = Skew(D), sigma = sin(theta), gamma = cos(theta), lambda = |D'|

#include "chapters/02_basic_concepts/05_rotation_about_moving_axis/rotating_axis.hpp"

namespace oddity {

namespace ex02_05 {

using namespace rotating_axis;

constexpr Parameter parameters[] = {
    {"t", 1, "s", "time at which w is computed", -10, 10},
    {"alpha", 0.5, "rad", "angle of the axis D from z", 0, 3.14},
    {"Omega", 2, "rad/s", "rate at which D goes round z", -20, 20},
    {"nu", 3, "rad/s", "rate of the angle theta", -20, 20},
    {"seed", 1, "", "of the random motions in the proof", 0, 1e9, whole_number},
};

/// Skew(D') against differences of S = Skew(D(t)), extrapolated.
Claim derivative_of_s(const std::vector<Moment>& moments) {
  const auto with = [&](const char* text, double k) {
    Worst worst("S', Skew(D') against extrapolated differences", "Skew(D')",
                "differences of Skew(D(t)), extrapolated");
    for (M m : moments)
      worst.see(skew(k * m.D_dot), m.S_slope.value,
                {m.S_slope.error_estimate, "the extrapolation's error estimate"}, m.lambda, m.where());
    return Reading{text, {worst.check()}};
  };
  return claim("2.5-derivative_of_s", 321, "S' = Skew(D')", with("as printed", 1),
               {with("a sign flipped", -1)});
}

std::vector<Claim> claims(double seed) {
  const Moments moments(seed);
  const std::string duals = "dual numbers", by_quaternion = "quaternion and dual numbers";
  // A line of the proof that holds whatever |D'| is.
  const auto line = [&](const char* id, int number, const char* says, const char* quantity, auto sides) {
    return formula(id, number, says, quantity, by_quaternion, moments.moving, 1, -1, sides);
  };
  // The same with a fixed axis too.
  const auto result = [&](const char* id, int number, const char* says, const char* quantity, auto sides) {
    return formula(id, number, says, quantity, by_quaternion, moments.all, 1, -1, sides);
  };
  // A line about the skew operator alone.
  const auto about_skew = [&](const char* id, int number, const char* says, const char* quantity,
                              const char* route, double near, auto sides) {
    return formula(id, number, says, quantity, route, moments.moving, 1, near, sides);
  };
  // A line of the proof that needs |D'| = 1.
  const auto against = [&](const std::string& route) {
    return [&, route](const char* id, int number, const char* says, const char* quantity, auto sides) {
      const auto with = [&](const char* text, const std::vector<Moment>& samples, double k) {
        return reading(text, quantity, route, samples, [&](M m) { return sides(m, k); });
      };
      return claim(id, number, std::string(says) + " (|D'| = 1)",
                   with("where |D'| = 1", moments.unit_speed, 1),
                   {with("where |D'| = 1, a sign flipped", moments.unit_speed, -1),
                    with("for any |D'|", moments.any, 1)});
    };
  };
  const auto unit_line = against(by_quaternion), unit_line_of_frame = against("D and D' by dual numbers"),
             unit_line_of_skew = against("products with the matrix S' by dual numbers");

  Claim frame{"2.5-orthonormal_frame", 337, "D, D' and D x D' are unit vectors at right angles"};
  const auto gram = [](const Matrix3& U) {
    return Sides{transpose(U) * U, identity(), 1 + size_of(U) * size_of(U)};
  };
  const char* route = "the unit matrix";
  frame.printed = reading("U2 = D', U3 = D x D'", "U^T U", route, moments.any,
                          [&](M m) { return gram(Matrix3::columns(m.U[0], m.U[1], m.U[2])); });
  frame.corrected = reading("U2 = D'/|D'|, U3 = D x U2", "U^T U", route, moments.any, [&](M m) {
    return gram(Matrix3::columns(m.U[0], m.U[1] / m.lambda, m.U[2] / m.lambda));
  });
  frame.near_misses = {reading("U2 = D'/|D'|, U3 = D x D'", "U^T U", route, moments.any, [&](M m) {
    return gram(Matrix3::columns(m.U[0], m.U[1] / m.lambda, m.U[2]));
  })};
  frame.kind = Fault::left_out;
  frame.root = "length of the axis' rate";
  frame.why =
      "$\\dot{\\mathbf D}$ is perpendicular to $\\mathbf D$, but its length $\\lambda=|\\dot{\\mathbf D}|$ "
      "is $1$ only when the axis moves so; it is $0$ when the axis is fixed, and then there is no such "
      "frame at all. With the printed vectors "
      "$\\mathbf U_2\\times\\mathbf U_3$ and $\\dot S\\mathbf U_3$ are $\\lambda^2\\mathbf U_1$, and the "
      "lines that use them fail for $\\lambda\\ne1$. With $\\mathbf U_2=\\dot{\\mathbf D}/\\lambda$ every "
      "$\\sigma$ and every $1-\\gamma$ of the last steps gets a factor $\\lambda$, which $\\lambda\\mathbf "
      "U_2=\\dot{\\mathbf D}$ takes up again: the result holds for every $\\lambda$, zero included.";

  Claim singular{"2.5-applied_to_singular", 335,
                 "what is said of an invertible matrix (line 327) is applied to R' R^T"};
  const auto determinants = [&](const char* text, double unit, bool zero) {
    return compare(text, "the determinant", zero ? "0" : "1 + |w|^2", moments.all, [=](M m) {
      const Matrix3 shifted = R_dot_R_transposed(m) + unit * identity();
      return Sides{determinant(shifted), zero ? 0 : 1 + dot(m.w, m.w), std::pow(m.size, 3)};
    });
  };
  long regular = 0;
  for (M m : moments.all)
    regular += std::abs(determinant(R_dot_R_transposed(m))) > 1e-9 * std::pow(length(m.w), 3);
  const long count = static_cast<long>(moments.all.size());
  singular.printed = {"R' R^T is invertible",
                      {never("moments at which R' R^T is singular", count - regular, count)}};
  singular.corrected = {
      "R' R^T is singular, and determined by its images all the same",
      {determinants("det R' R^T", 0, true),
       compare("R' R^T from its images, A U^T", "A U^T", "R' R^T", moments.unit_speed, [](M m) {
         const Matrix3 M = R_dot_R_transposed(m);
         const Matrix3 U = Matrix3::columns(m.U[0], m.U[1], m.U[2]);
         return Sides{(M * U) * transpose(U), M, m.frame_size};
       })}};
  singular.near_misses = {{"so is R' R^T + I", {determinants("det (R' R^T + I)", 1, true)}}};
  singular.kind = Fault::counterexample;
  singular.root = "a singular matrix";
  singular.why =
      "A skew $3\\times3$ matrix is never invertible, since $\\det S=\\det S^T=-\\det S$: $\\dot RR^T$ has "
      "the "
      "eigenvalues $0,\\pm i|\\mathbf w|$ and the determinant 0 at every moment. The conclusion stands, for "
      "$M=AU^T$ follows from $MU=A$ for every matrix $M$: it is $U$ that has to be invertible.";

  const auto w_of_the_text = [](M m, double k) {
    return m.theta_dot * m.D + m.sigma * m.D_dot + k * (1 - m.gamma) * cross(m.D, m.D_dot);
  };
  return {
      claim("2.5-skew_of_w", 317, "Skew(w) = R' R^T",
            reading("R' R^T", "Skew(w)", "2 q' q* in dual numbers", moments.all,
                    [](M m) {
                      return Sides{R_dot_R_transposed(m), skew(m.w), m.size};
                    }),
            {reading("R^T R', which has w in the body's frame", "Skew(w)", "2 q' q* in dual numbers",
                     moments.all,
                     [](M m) {
                       return Sides{transpose(m.R) * m.R_dot, skew(m.w), m.size};
                     })}),
      result("2.5-rotation_matrix", 319, "R = I + sigma S + (1 - gamma) S^2", "R",
             [](M m, double k) {
               return Sides{identity() + k * m.sigma * m.S + (1 - m.gamma) * (m.S * m.S), m.R,
                            1 + std::abs(m.theta)};
             }),
      result("2.5-transpose", 319, "R^T = I - sigma S + (1 - gamma) S^2", "R^T",
             [](M m, double k) {
               return Sides{identity() - k * m.sigma * m.S + (1 - m.gamma) * (m.S * m.S), transpose(m.R),
                            1 + std::abs(m.theta)};
             }),
      derivative_of_s(moments.moving),
      line("2.5-derivative_of_r", 323,
           "R' = sigma S' + theta' gamma S + (1 - gamma)(S S' + S' S) + theta' sigma S^2", "R'",
           [](M m, double k) {
             const Matrix3 product = m.S * m.S_dot + m.S_dot * m.S;
             return Sides{m.sigma * m.S_dot + m.theta_dot * m.gamma * m.S + (1 - m.gamma) * product +
                              k * m.theta_dot * m.sigma * (m.S * m.S),
                          m.R_dot, m.size};
           }),
      formula("2.5-no_power_rule", 325, "the derivative of S^2 is S S' + S' S, not 2 S S'", "(S^2)'", duals,
              moments.moving, 1, 0,
              [](M m, double k) {
                return Sides{(2 - k) * (m.S * m.S_dot) + k * (m.S_dot * m.S), m.S2_dot, m.size};
              }),
      formula("2.5-determined_by_images", 327,
              "three independent vectors and their images determine an invertible matrix (and any other)",
              "M", "the matrix itself", moments.unit_speed, 1, 0,
              [](M m, double k) {
                const Matrix3 matrix = m.R_dot + 2.0 * identity();
                const auto& [U1, U2, U3] = m.U;
                const Vector3 a = U1 + U2, b = U2 + 2.0 * U3, c = U3 - U1;
                const double volume = dot(a, cross(b, c));
                const Matrix3 sum = outer(matrix * a, cross(b, c)) + outer(matrix * b, cross(c, a)) +
                                    k * outer(matrix * c, cross(a, b));
                return Sides{1 / volume * sum, matrix, 10 * m.size};
              }),
      formula("2.5-frame_is_a_rotation", 331, "U is a rotation matrix, its inverse its transpose",
              "U^T U, det U", "a rotation", moments.unit_speed, 1, -1,
              [](M m, double k) {
                const Matrix3 U = Matrix3::columns(m.U[0], m.U[1], k * m.U[2]);
                return Sides{joined(transpose(U) * U, determinant(U)), joined(identity(), 1), 4};
              }),
      formula("2.5-matrix_from_images", 333, "M = A U^T", "M", "the matrix itself", moments.unit_speed, 1, 0,
              [](M m, double k) {
                const Matrix3 U = Matrix3::columns(m.U[0], m.U[1], m.U[2]), A = m.R_dot * U;
                return Sides{A * (k == 1 ? transpose(U) : U), m.R_dot, m.size};
              }),
      singular,
      frame,
      unit_line_of_frame("2.5-cross_products", 341, "U1 = U2 x U3, U2 = U3 x U1, U3 = U1 x U2", "U1, U2, U3",
                         [](M m, double k) {
                           const auto& [U1, U2, U3] = m.U;
                           return Sides{joined(k * cross(U2, U3), cross(U3, U1), cross(U1, U2)),
                                        joined(U1, U2, U3), m.frame_size};
                         }),
      about_skew(
          "2.5-images_under_s", 343, "S U1 = 0, S U2 = U3, S U3 = -U2", "S U1, S U2, S U3",
          "products with the matrix S", -1,
          [](M m, double k) {
            const auto& [U1, U2, U3] = m.U;
            return Sides{joined(Vector3{}, U3, -k * U2), joined(m.S * U1, m.S * U2, m.S * U3), m.frame_size};
          }),
      unit_line_of_skew("2.5-images_under_s_dot", 345, "S' U1 = -U3, S' U2 = 0, S' U3 = U1",
                        "S' U1, S' U2, S' U3",
                        [](M m, double k) {
                          const auto& [U1, U2, U3] = m.U;
                          return Sides{joined(-U3, Vector3{}, k * U1),
                                       joined(m.S_dot * U1, m.S_dot * U2, m.S_dot * U3), m.frame_size};
                        }),
      line("2.5-rt_u1", 349, "R^T U1 = U1 - sigma S U1 + (1 - gamma) S^2 U1 = U1", "R^T U1",
           [](M m, double k) {
             const Vector3& U1 = m.U[0];
             const Vector3 step = U1 - m.sigma * (m.S * U1) + (1 - m.gamma) * (m.S * (m.S * U1));
             return Sides{joined(step, k * U1), joined(back(m, U1), back(m, U1)), m.frame_size};
           }),
      line("2.5-rt_u2", 351, "R^T U2 = U2 - sigma U3 - (1 - gamma) U2 = gamma U2 - sigma U3", "R^T U2",
           [](M m, double k) {
             const auto& [U1, U2, U3] = m.U;
             return Sides{joined(U2 - m.sigma * U3 - (1 - m.gamma) * U2, m.gamma * U2 - k * m.sigma * U3),
                          joined(back(m, U2), back(m, U2)), m.frame_size};
           }),
      line("2.5-rt_u3", 353, "R^T U3 = U3 + sigma U2 - (1 - gamma) U3 = sigma U2 + gamma U3", "R^T U3",
           [](M m, double k) {
             const auto& [U1, U2, U3] = m.U;
             return Sides{joined(U3 + m.sigma * U2 - (1 - m.gamma) * U3, k * m.sigma * U2 + m.gamma * U3),
                          joined(back(m, U3), back(m, U3)), m.frame_size};
           }),
      line("2.5-r_dot_u1", 357, "R' U1 = (1 - gamma) U2 - sigma U3", "R' U1",
           [](M m, double k) {
             return Sides{(1 - m.gamma) * m.U[1] - k * m.sigma * m.U[2], rate(m, m.U[0]), m.frame_size};
           }),
      unit_line("2.5-r_dot_u2", 359, "R' U2 = (1 - gamma) U1 - theta' sigma U2 + theta' gamma U3", "R' U2",
                [](M m, double k) {
                  const auto& [U1, U2, U3] = m.U;
                  const double w = m.theta_dot;
                  return Sides{(1 - m.gamma) * U1 - k * w * m.sigma * U2 + w * m.gamma * U3, rate(m, U2),
                               m.frame_size};
                }),
      unit_line(
          "2.5-r_dot_u3", 361, "R' U3 = sigma U1 - theta' gamma U2 - theta' sigma U3", "R' U3",
          [](M m, double k) {
            const auto& [U1, U2, U3] = m.U;
            const double w = m.theta_dot;
            return Sides{m.sigma * U1 - w * m.gamma * U2 - k * w * m.sigma * U3, rate(m, U3), m.frame_size};
          }),
      line("2.5-composed_u1", 367, "R' R^T U1 = R' U1 = (1 - gamma) U2 - sigma U3", "R' R^T U1",
           [](M m, double k) {
             const Vector3 text = (1 - m.gamma) * m.U[1] - k * m.sigma * m.U[2];
             return Sides{joined(rate(m, m.U[0]), text), joined(turned(m, m.U[0]), turned(m, m.U[0])),
                          m.frame_size};
           }),
      unit_line("2.5-composed_u2", 369, "R' R^T U2 = R'(gamma U2 - sigma U3) = -(1 - gamma) U1 + theta' U3",
                "R' R^T U2",
                [](M m, double k) {
                  const auto& [U1, U2, U3] = m.U;
                  return Sides{joined(rate(m, m.gamma * U2 - m.sigma * U3),
                                      -(1 - m.gamma) * U1 + k * m.theta_dot * U3),
                               joined(turned(m, U2), turned(m, U2)), m.frame_size};
                }),
      unit_line(
          "2.5-composed_u3", 371, "R' R^T U3 = R'(sigma U2 + gamma U3) = sigma U1 - theta' U2", "R' R^T U3",
          [](M m, double k) {
            const auto& [U1, U2, U3] = m.U;
            return Sides{joined(rate(m, m.sigma * U2 + m.gamma * U3), m.sigma * U1 - k * m.theta_dot * U2),
                         joined(turned(m, U3), turned(m, U3)), m.frame_size};
          }),
      unit_line("2.5-columns", 375, "R' R^T U has the three images as columns", "R' R^T U",
                [](M m, double k) {
                  const Matrix3 U = Matrix3::columns(m.U[0], m.U[1], m.U[2]);
                  return Sides{columns_of_the_text(m, k), R_dot_R_transposed(m) * U, m.frame_size};
                }),
      unit_line("2.5-inverted", 379, "R' R^T is the matrix of columns times U^T", "R' R^T",
                [](M m, double k) {
                  const Matrix3 U = Matrix3::columns(m.U[0], m.U[1], m.U[2]);
                  return Sides{columns_of_the_text(m, k) * transpose(U), R_dot_R_transposed(m), m.frame_size};
                }),
      unit_line(
          "2.5-outer_products", 389,
          "R' R^T = theta'(U3 U2^T - U2 U3^T) + sigma(U1 U3^T - U3 U1^T) + (1 - gamma)(U2 U1^T - U1 U2^T)",
          "R' R^T",
          [](M m, double k) {
            const auto& [U1, U2, U3] = m.U;
            return Sides{m.theta_dot * (outer(U3, U2) - outer(U2, U3)) +
                             m.sigma * (outer(U1, U3) - outer(U3, U1)) +
                             k * (1 - m.gamma) * (outer(U2, U1) - outer(U1, U2)),
                         R_dot_R_transposed(m), m.frame_size};
          }),
      about_skew("2.5-skew_entries", 453, "B A^T - A B^T has the entries of A x B, arranged as printed",
                 "B A^T - A B^T", "outer products", -1,
                 [](M m, double k) {
                   const Vector3 A = m.w, B = m.R.column(0) + m.D_dot;
                   return Sides{collected(A, B, k), outer(B, A) - outer(A, B), m.size * m.size};
                 }),
      about_skew("2.5-skew_identity", 459, "B A^T - A B^T = Skew(A x B)", "B A^T - A B^T", "Skew(A x B)", -1,
                 [](M m, double k) {
                   const Vector3 A = m.w, B = m.R.column(0) + m.D_dot;
                   return Sides{k * (outer(B, A) - outer(A, B)), skew(cross(A, B)), m.size * m.size};
                 }),
      unit_line("2.5-sum_of_cross_products", 465,
                "Skew(w) = theta' Skew(U2 x U3) + sigma Skew(U3 x U1) + (1 - gamma) Skew(U1 x U2)", "Skew(w)",
                [](M m, double k) {
                  const auto& [U1, U2, U3] = m.U;
                  return Sides{m.theta_dot * skew(cross(U2, U3)) + k * m.sigma * skew(cross(U3, U1)) +
                                   (1 - m.gamma) * skew(cross(U1, U2)),
                               R_dot_R_transposed(m), m.frame_size};
                }),
      result("2.5-sum_of_frame", 467, "Skew(w) = theta' Skew(U1) + sigma Skew(U2) + (1 - gamma) Skew(U3)",
             "Skew(w)",
             [](M m, double k) {
               const auto& [U1, U2, U3] = m.U;
               return Sides{m.theta_dot * skew(U1) + k * m.sigma * skew(U2) + (1 - m.gamma) * skew(U3),
                            R_dot_R_transposed(m), m.frame_size};
             }),
      result("2.5-sum_of_axis", 469,
             "Skew(w) = theta' Skew(D) + sin(theta) Skew(D') + (1 - cos(theta)) Skew(D x D')", "Skew(w)",
             [&](M m, double k) {
               return Sides{skew(w_of_the_text(m, k)), R_dot_R_transposed(m), m.frame_size};
             }),
      about_skew(
          "2.5-skew_is_one_to_one", 473,
          "Skew(A) = Skew(B) implies A = B: the squares of the entries' differences add up to 2 |A - B|^2",
          "2 |A - B|^2", "squared entries of Skew(A) - Skew(B)", 0.5,
          [](M m, double k) {
            const Vector3 A = m.w, B = m.R.column(0) + m.D_dot;
            double squares = 0;
            for (double entry : skew(A) - skew(B)) squares += entry * entry;
            return Sides{2 * k * dot(A - B, A - B), squares, m.size * m.size};
          }),
      result("2.5-angular_velocity", 475,
             "w = theta' D + sin(theta) D' + (1 - cos(theta)) D x D', whatever |D'| is", "w",
             [&](M m, double k) {
               return Sides{w_of_the_text(m, k), m.w, m.size};
             }),
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  return {
      claims(p["seed"]),
      {angular_velocity(p["t"], {p["alpha"], p["Omega"], p["nu"]}, truth)},
      {{"length of the axis' rate",
        R"(An axis that moves at half a radian per second has $|\dot{\mathbf D}|=0.5$: the determinant of the )"
        R"(printed frame is 0.25, and a body that is drawn in it loses three quarters of its volume.)"},
       {"a singular matrix",
        R"(A program that inverts $\dot RR^T$ divides by its determinant, which is 0 at every moment.)"}}};
}

}  // namespace ex02_05

Exercise exercise_2_5() {
  using namespace ex02_05;
  return {
      "Rotation about a moving axis",
      "A body is turned by the angle $\\theta(t)$ about the unit axis $\\mathbf D(t)$: show that its "
      "angular velocity is $\\mathbf w=\\dot\\theta\\mathbf D+\\sin\\theta\\,\\dot{\\mathbf "
      "D}+(1-\\cos\\theta)\\,\\mathbf D\\times\\dot{\\mathbf D}$. Below `U1`, `U2`, `U3` are $\\mathbf D$, "
      "$\\dot{\\mathbf D}$ and $\\mathbf D\\times\\dot{\\mathbf D}$, `S` is Skew(D), `sigma` and `gamma` are "
      "the sine and the cosine of $\\theta$.",
      parameters,
      {},
      study};
}

}  // namespace oddity
