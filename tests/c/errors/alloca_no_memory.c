#include <alloca.h>

int main(void)
{
    int i;
    for (i = 0; i < 100000; i++)
        *(char *)alloca(1000000) = i; // error: no memory for local array
    return 0;
}
