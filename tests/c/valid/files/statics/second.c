struct state { double steps; };
static double count = 0.5;
static struct state helper(int n) { static int calls; struct state s = {n + count}; calls++; return s; }
double other(int n) { count *= 2; return helper(n).steps; }
