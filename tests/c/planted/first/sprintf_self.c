/* A text is lengthened by printing it into itself. */
#include <stdio.h>
#include <string.h>
int main(void)
{
    char log[64] = "start", copy[64];
    int i;
    for (i = 0; i < 3; i++) {
        strcpy(copy, log);
        sprintf(log, "%s %d", PLANT(log, copy), i); // error: overlapping copy
    }
    puts(log);
    return 0;
}
