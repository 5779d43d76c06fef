/* A directive that is none. */
#incldue <stdio.h> // error: there is no directive '#incldue'

int main(void)
{
    return 0;
}
