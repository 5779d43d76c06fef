#include "scale.h"
int scale(int n) { return n * 3; }
int other(int n) { return scale(n) + 1; }
