/* #include wants a name in quotes or angle brackets. */
#include stdio.h // error: write "name.h" or <name.h>
#include // error: '#include' must be followed by a header's name

int main(void)
{
    return 0;
}
