/* Writing through a null pointer. */
#include <stdio.h>

int main(void)
{
    char *text = NULL;

    printf("before\n");
    *text = 'x'; // error: null pointer
    printf("after\n");
    return 0;
}
