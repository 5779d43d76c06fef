/* A constant member of a table is counted up through a pointer without const. */
#include <stdio.h>
struct command { char letter; int used; };
static const struct command fixed[2] = {{'f', 0}, {'b', 0}};
static struct command loose[2] = {{'f', 0}, {'b', 0}};
static struct command *find(int letter)
{
    int i;
    for (i = 0; i < 2; i++)
        if (fixed[i].letter == letter)
            return PLANT((struct command *)&fixed[i], &loose[i]);
    return NULL;
}
int main(void)
{
    find('b')->used++; // error: write to read-only memory
    printf("%d\n", loose[1].used);
    return 0;
}
