/* The length is the difference to a block that was allocated later. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
int main(void)
{
    char *a = malloc(16), *b = malloc(16), *end;
    strcpy(a, "go");
    strcpy(b, "go");
    end = PLANT(b, a) + 2;
    printf("%d\n", (int)(end - a) > 0); // error: unrelated pointers
    free(a);
    free(b);
    return 0;
}
