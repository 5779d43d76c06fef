/* A speed in mm/s is printed as if it were a whole number. */
#include <stdio.h>

int main(void)
{
    double speed = 250.0;

    printf("%s: %d mm/s\n", "robot0", speed); // error: mismatched argument
    return 0;
}
