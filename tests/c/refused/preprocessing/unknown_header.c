/* A header that is not there. */
#include <stdio.h>
#include "no_such_header.h" // error: no_such_header.h

int main(void)
{
    return 0;
}
