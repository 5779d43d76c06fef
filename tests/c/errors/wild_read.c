/* Example: a pointer far beyond the end of memory. */
#include <stdio.h>

int main(void)
{
    int *wild = (int *) 0xDEADBEEC;

    printf("before\n");
    return *wild; // error: pointer outside memory
}
