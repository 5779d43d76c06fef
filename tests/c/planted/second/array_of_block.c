/* An array of a block is returned from a while loop. */
#include <stdio.h>
static char keep[8] = "kept";
int main(void)
{
    char *word = keep;
    int n = 0;
    while (n < 2) {
        char local[8];
        sprintf(local, "w%d", n);
        if (n++ == 1) {
            word = PLANT(local, keep);
            break;
        }
    }
    return word[0] == 'w'; // error: use after scope
}
