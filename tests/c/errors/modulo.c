/* The remainder of a division by zero. */
#include <stdio.h>

int main(void)
{
    int n, size = 3;

    for (n = 0; n < 10; n++) {
        printf("%d ", n % size); // error: division by zero
        size--;
    }
    return 0;
}
