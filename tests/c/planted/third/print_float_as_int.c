/* A speed is printed as a whole number. */
#include <stdio.h>
int main(void)
{
    float speed = 2.5f;
    printf("robot %d: %d mm/s\n", 1, PLANT(speed, (int)speed)); // error: mismatched argument
    return 0;
}
