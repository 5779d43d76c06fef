/* abort() stops the program at once; what was written before has come out or not. */
#include <stdlib.h>

static void give_up(void)
{
    abort(); // error: abort called
}

int main(void)
{
    give_up();
    return 0;
}
