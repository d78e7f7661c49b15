#include "problem/template.hpp"

namespace oddity::problem {

const std::string_view begun = R"toml(# A problem of your own. It runs as it is:
#   oddity choose THIS     the model, the algorithm and the step that it needs
#   oddity solve THIS k=40N/m     every model by every algorithm
#   oddity chart THIS; oddity stability THIS
title = "A mass on a spring, with friction"

# Each letter with its value, its unit and, where it matters, its range.
[parameters]
m = { value = "2 kg, 0.1 to 100", says = "the mass" }
k = { value = "30 N/m, 1 to 1000", says = "the spring" }
c = { value = "0.5 N s/m, 0 to 10", says = "friction" }
y0 = { value = "5 cm, 1 to 50", says = "how far it is pulled" }

# Abbreviations, of time t too. A unit follows a numeral; a product is written m g or m*g.
[given]
push = "if(t < 0.5 s, 1 N, 0)"

# Models, from the least to the richest, the last of which is taken for true. One may be a closed form.
[model."without friction"]
closed = { y = "y0 cos(sqrt(k/m) t)" }

# Equations of any order, linear in their highest rates y''.
[model."spring and friction"]
equations = ["m y'' = -k y - c y' + push"]
start = { y = "y0", "y'" = "0 m/s" }
# Or, instead of equations:
#   lagrangian = "m/2 y'^2 - k/2 y^2"
#   dissipation = "c/2 y'^2"
#   forces = { y = "push" }

# What is seen of every model, and its unit. Another formula: y = { unit = "m", is = "y - y0" }.
[observe]
y = "m"

# What `choose` is asked unless the command line says else.
[need]
error = "1 mm"
horizon = "10 s"
fps = 60
)toml";

}  // namespace oddity::problem
