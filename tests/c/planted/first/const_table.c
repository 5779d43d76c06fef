/* A constant table is changed through a cast. */
#include <stdio.h>
static const int limit[3] = {10, 20, 30};
static int own[3] = {10, 20, 30};
static void raise(int *table) 
{
    table[1] += 5; // error: write to read-only memory
}
int main(void)
{
    raise(PLANT((int *)limit, own));
    printf("%d\n", limit[1]);
    return 0;
}
