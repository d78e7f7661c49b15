\\ What elimination costs, counted entry by entry: the operations mu (a product), alpha (a sum) and delta (a quotient).

\\ Clearing column k of an n x (n + 1) matrix below and, with `above`, above its pivot: a row becomes
\\ a_kk row - a_ik (row k). An entry under a zero of row k is only multiplied.
clear(n, k, above) = {
  my(cost = [0, 0, 0], nonzero = (i, j) -> i == j || j > n || j >= k);
  for(i = if(above, 1, k + 1), n, if(i != k,
    for(j = 1, n + 1, if(j != k && nonzero(i, j) && (i >= k || j == i || j > k),
      cost += if(j > k, [2, 1, 0], [1, 0, 0])))));
  cost;
}
clearing(k) = n -> clear(n, k, 1);
full(n) = sum(k = 1, n, clear(n, k, 1));
\\ Back substitution: row k has n - k terms to take away, and a quotient.
forward(n) = sum(k = 1, n, clear(n, k, 0) + [n - k, n - k, 1]);

\\ The count at any n, a cubic: through the counts of four sizes, and seen at a fifth.
at(n, count) = {
  my(sizes = [3, 4, 5, 6], through(n) = vector(3, i, polinterpolate(sizes, vector(4, j, count(sizes[j])[i]), n)));
  if(through(11) != count(11), error("no cubic"));
  through(n);
}
