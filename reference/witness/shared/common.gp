\\ What the witnesses share: how they are printed, and how a motion is followed.
default(realprecision, 60);

digits30(x) = {
  if(type(x) == "t_STR", return(x), abs(x) < 1e-40, return("0"));
  my(parts = strsplit(strprintf("%.30g", x), " e"), c = Vecsmall(parts[1]), n = #c);
  if(#strsplit(parts[1], ".") == 2, while(c[n] == 48, n--); if(c[n] == 46, n--));
  Str(strchr(c[1..n]), if(#parts == 2, Str("e", parts[2]), ""));
}
words(v) = {
  my(list = if(type(v) == "t_VEC" || type(v) == "t_COL", Vec(v), [v]), text = "");
  for(i = 1, #list, text = Str(text, if(i > 1, " ", ""), digits30(list[i])));
  text;
}
apart(a, b) = vecmax(abs(concat([0], Vec(a)) - concat([0], Vec(b))));
vanishes(a) = apart(a, 0*a) < 1e-40;
none = "none";        \\ printed: no number
nonzero = "nonzero";  \\ printed: something that is not zero, which a part of what is right is
differ(right, printed) = {
  if(printed == nonzero, return(#select(vanishes, concat([], right)) > 0));
  type(printed) == "t_STR" || apart(right, printed) > 1e-9*apart(printed, 0*printed);
}
say(seen, check, at, right, printed) = {
  if(!differ(right, printed), error("what is printed is right: ", printed));
  print(seen, ",", check, ",", words(at), ",", words(right), ",", words(printed));
}

compare(right, corrected) = {
  if(apart(right, corrected) > 1e-30*(1 + apart(right, 0*right)),
    error("the corrected formula is wrong: ", corrected, " for ", right));
}

\\ The suite's check of this name ("printed 1": the first of what is printed) has both at these letters, which are
\\ those of its `where`.
both(check, at, right, printed, corrected = right) = compare(right, corrected); say("both", check, at, right, printed);
\\ The suite has what is right alone.
one(check, at, right, printed) = say("right", check, at, right, printed);
\\ The suite has neither at these letters. The corrected formula, written out again, has to be right.
formula(at, right, printed, corrected) = compare(right, corrected); say("formula", "", at, right, printed);
\\ A counterexample, or a case that is left out: what is, and what it should be by what is printed.
case(at, right, printed) = say("case", "", at, right, printed);

cross(a, b) = [a[2]*b[3] - a[3]*b[2], a[3]*b[1] - a[1]*b[3], a[1]*b[2] - a[2]*b[1]];
dot(a, b) = sum(i = 1, #a, a[i]*b[i]);
norm2(a) = sqrt(dot(a, a));
\\ The k-th derivative at t of a function of the time.
rate(f, t, k = 1) = my(s = f(t + x + O(x^(k + 3)))); apply(c -> k! * polcoef(c + O(x^(k + 1)), k), s);

\\ One step of y' = f(t, y): Gragg's midpoint rule extrapolated to the order 2n.
step(f, t, y, h, n = 14) = {
  my(T = vector(n), z0, z1, z2, m, s);
  for(j = 1, n,
    m = 2*j; s = h/m; z0 = y; z1 = y + s*f(t, y);
    for(i = 1, m - 1, z2 = z0 + 2*s*f(t + i*s, z1); z0 = z1; z1 = z2);
    T[j] = (z0 + z1 + s*f(t + h, z1))/2;
    forstep(k = j - 1, 1, -1, T[k] = T[k + 1] + (T[k + 1] - T[k])/((j/k)^2 - 1)));
  T[1];
}
\\ y at the time t from y at 0, in so many steps.
follow(f, y, t, steps) = y = 1.*y; for(i = 0, steps - 1, y = step(f, i*t/steps, y, t/steps)); y;

\\ exp(A) by its series, of A divided by 2^8.
exponential(A) = {
  my(B = A/2.^8, term = matid(#A), E = term);
  for(k = 1, 60, term = term*B/k; E += term);
  for(k = 1, 8, E = E^2);
  E;
}
