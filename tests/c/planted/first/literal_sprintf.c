/* sprintf prints into a literal that a pointer was initialised with. */
#include <stdio.h>
static char room[16] = "................";
static char *message = PLANT("................", room);
int main(void)
{
    sprintf(message, "%d", 42); // error: write to read-only memory
    puts(message);
    return 0;
}
