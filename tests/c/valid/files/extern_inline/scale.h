extern __inline__ __attribute__((__gnu_inline__)) int scale(int n) { return n * 2; }
int other(int n);
