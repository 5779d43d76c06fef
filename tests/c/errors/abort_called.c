/* abort() stops the program at once; buffered output may be lost. */
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
