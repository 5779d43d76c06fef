/* LLONG_MIN / -1 does not fit. */
#include <limits.h>

int main(void)
{
    long long n = LLONG_MIN;

    n /= -1 - (n == 0); // error: division overflow
    return n > 0;
}
