/* Something that is neither a declaration nor a statement. */
#include <stdio.h>

printf("hello\n"); // error: expected identifier before '"hello\n"'

int main(void)
{
    return 0;
}
