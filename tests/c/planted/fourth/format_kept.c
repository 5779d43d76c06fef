/* A text is extended by itself. */
#include <stdio.h>

int main(void)
{
    char line[40] = "sonar", before[40] = "sonar";

    for (int i = 0; i < 2; i++) {
        sprintf(line, "%s %d", PLANT(line, before), i); // error: overlapping copy
        snprintf(before, sizeof before, "%s.", "sonar");
    }
    puts(line);
    return 0;
}
