/* A header's functions without the C file that has them. */
#include "nav.h"

int main(void)
{
    heading = 3; // error: is its C file missing from the command line?
    return prints(90); // error: nav.h:4; is its C file missing from the command line?
}
