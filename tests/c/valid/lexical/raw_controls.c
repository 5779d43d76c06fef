/* A vertical tab and a form feed inside literals. */
#include <stdio.h>
int main(void) { const char *s = "abc"; printf("%d %d %d %d\n", s[1], s[3], '', (int)''); return 0; }
