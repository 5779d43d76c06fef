/* One array, declared with and without its length, and sized by the file that defines it. */
#include <stdio.h>

extern int table[];
extern const char *const names[3];
int grid[2][3];
extern int total(void);

int main(void)
{
    extern int limit;
    grid[1][2] = limit;
    printf("%d %s %d\n", table[4], names[2], total());
    return 0;
}
