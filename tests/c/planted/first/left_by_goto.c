/* goto leaves two blocks. */
#include <stdio.h>
int main(void)
{
    char *message = "none", *kept = message;
    int n = 3;
    if (n > 2) {
        char text[20] = "three";
        if (text[0] == 't') {
            message = PLANT(text, kept);
            goto done;
        }
    }
done:
    puts(message); // error: use after scope
    return 0;
}
