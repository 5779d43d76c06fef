/* argv contains at least the program's name, and ends with a null pointer. */
#include <stdio.h>

int main(int argc, char *argv[])
{
    int i;

    printf("%d\n", argc);
    for (i = 1; i < argc; i++)
        printf("%s\n", argv[i]);
    printf("%d %d\n", argv[argc] == 0, argv[0] != 0);
    return 0;
}
