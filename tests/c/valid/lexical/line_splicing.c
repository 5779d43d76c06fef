/* A backslash at the end of a line joins it with the next, anywhere (C17 5.1.1.2). */
#include <stdio.h>

#define LONG_ONE(a, \
                 b) \
    ((a) + \
     (b))

// A comment that goes on \
   in this line: nothing of this is code: int main(void) { return 1; }

int ma\
in(void)
{
    int val\
ue = 4\
2;
    printf("%d %d\n", LONG_ONE(1, 2), value);
    printf("one \
two\n");
    pr\
int\
f("%s %d\n", "three" /* \
*/ " four", __LINE__);
    ret\
urn 0;
}
