/* One mistake of the preprocessor hides no other mistake. */
#inclde <stdio.h> // error: unknown directive '#inclde'
#define TWICE(x) ((x) + (x))

int main(void)
{
    int n = TWICE(1, 2); // error: macro 'TWICE' requires 1 argument, but has 2
    return n;
}
#undef // error: '#undef' must be followed by a name
