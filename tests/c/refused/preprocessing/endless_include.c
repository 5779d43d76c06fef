/* A file that includes itself. */
#include "endless_include.c" // error: include

int main(void)
{
    return 0;
}
