/* #include wants a name in quotes or angle brackets. */
#include stdio.h // error: a header is named as "name.h" or <name.h>
#include // error: '#include' needs a header's name

int main(void)
{
    return 0;
}
