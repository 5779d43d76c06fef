/* An outer block keeps a pointer into an inner one, and both are left by goto. */
#include <stdio.h>
int main(void)
{
    double none = 0, *best = &none;
    {
        double a = 1.5;
        {
            double b = 2.5;
            best = PLANT(&b, &none);
            if (a < b)
                goto out;
        }
        best = &none;
    }
out:
    printf("%g\n", *best); // error: use after scope
    return 0;
}
