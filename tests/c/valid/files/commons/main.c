/* One name, defined in three files, in one of them with an initialiser. */
#include <stdio.h>

int State[45];
int mode;
char *title;
extern void set(void), show(void);

int main(void)
{
    set();
    State[44] = State[0] + mode;
    show();
    printf("%s\n", title);
    return 0;
}
