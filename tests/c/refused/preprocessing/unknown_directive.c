/* A directive that is none. */
#incldue <stdio.h> // error: unknown directive '#incldue'

int main(void)
{
    return 0;
}
