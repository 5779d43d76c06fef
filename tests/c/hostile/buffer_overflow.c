/* The classic: a string copied into a buffer that is too small for it. */
// ends: any
#include <stdio.h>
#include <string.h>

static void greet(const char *name)
{
    char buffer[8];

    strcpy(buffer, name);
    printf("hello %s\n", buffer);
}

int main(void)
{
    static char name[5000];

    memset(name, 'A', sizeof name - 1);
    greet(name);
    return 0;
}
