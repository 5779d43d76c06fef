/* extern in an inner block finds the outer object past a local that hides it. */
#include <stdio.h>

int level = 1;
static int hidden = 10;
int next_level(void);

static int look(void)
{
    int level = 2;
    {
        extern int level;
        level += 100;
    }
    return level;
}

int main(void)
{
    extern int level;
    int hidden = 20;

    printf("%d ", look());
    printf("%d\n", level);
    {
        static int hidden = 30;
        hidden++;
        printf("%d\n", hidden);
    }
    printf("%d\n", hidden);
    printf("%d\n", next_level());
    return 0;
}

int next_level(void)
{
    return ++level + hidden;
}
