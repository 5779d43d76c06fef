/* The length of what is printed depends on the numbers. */
#include <stdio.h>

static void label(int robot, double x, double y)
{
    char text[20];

    sprintf(text, "%d at %.1f, %.1f", robot, x, y); // error: out of bounds
    puts(text);
}

int main(void)
{
    label(1, 2.5, -3.5);
    label(12, 1234.5, -9876.5);
    return 0;
}
