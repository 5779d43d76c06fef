/* A name that was never declared. */
#include <stdio.h>

int main(void)
{
    int speed = 100;

    printf("%d\n", sped); // error: undeclared
    return speed;
}
