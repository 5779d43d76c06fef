/* Comparisons with their signs in the wrong order, or apart. */
int main(void)
{
    int i = 4;
    if (i => 3) i = 2; // error: did you mean '>='?
    if (i =< 3) i = 1; // error: did you mean '<='?
    if (i < = 3) i = 1; // error: did you mean '<='?
    if (i = = 3) i = 1; // error: did you mean '=='?
    return i;
}
