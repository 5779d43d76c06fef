/* A literal indexed behind its end. */
#include <stdio.h>
int main(int argc, char **argv)
{
    int month = PLANT(13, 11) + argc - 1;
    char c = "JFMAMJJASOND"[month]; // error: out of bounds
    printf("%c\n", c ? c : '-');
    return 0;
}
