/* The list grows into another variable, and the old copy is made again. */
#include <stdlib.h>
#include <string.h>
static int *list;
int main(void)
{
    int *grown = malloc(40); // leak: 1
    list = grown;
    PLANT(list = 0, (void)0);
    grown = 0;
    list = realloc(list, 80);
    memset(list, 0, 80);
    return list[3];
}
