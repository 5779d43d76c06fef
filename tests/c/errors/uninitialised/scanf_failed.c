/* scanf finds no number and leaves the variable as it was. */
#include <stdio.h>

int main(void)
{
    int n;

    scanf("%d", &n);
    return n; // error: uninitialised read
}
