/* The index of an element is computed in the wrong table. */
#include <stdio.h>
struct item { int key, value; };
static struct item old[5], new[5];
static int index_of(struct item *p) { return p - old; } // error: unrelated pointers
int main(void) { printf("%d\n", index_of(PLANT(new, old) + 2) != 0); return 0; }
