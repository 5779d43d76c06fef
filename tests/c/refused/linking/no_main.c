/* A program without main. */
static int f(void) { return 1; }
int g(void) { return f(); }
// error: main (anywhere)
