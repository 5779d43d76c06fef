/* Inline functions in all their forms: declared before or after the definition, with and without extern. */
#include <stdio.h>

void first(void);
extern inline void first(void) { printf("first\n"); }
inline int second(int x) { return x + 1; }
int second(int x);
static inline int third(void);
static inline int third(void) { return 3; }
extern inline int fourth(int);
inline int fourth(int x) { return x * 2; }
__inline__ int fifth(void);
extern __inline__ int fifth(void) { return 9; }

int main(void)
{
    first();
    printf("%d %d %d %d\n", second(1), third(), fourth(4), fifth());
    return 0;
}
