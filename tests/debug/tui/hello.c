#include <stdio.h>

int main(void)
{
    printf("hello\n");
    fprintf(stderr, "and good bye\n");
    return 3;
}
