/* Example: a call through a null function pointer. */
#include <stdio.h>

static int (*handler)(int);

int main(void)
{
    printf("before\n");
    return handler(3); // error: bad function pointer
}
