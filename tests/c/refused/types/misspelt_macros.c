/* Names that are nearly those of macros. */
#include "Nclient.h"
#define FULL_SPEED 200

int main(void)
{
    int bumper = State[STATE_BUMPR]; // error: did you mean 'STATE_BUMPER'?
    return bumper + FUL_SPEED; // error: did you mean 'FULL_SPEED'?
}
