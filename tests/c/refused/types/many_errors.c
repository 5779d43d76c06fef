/* All errors of a file are reported in one run, in order. */
int main(void)
{
    int n = one; // error: one
    n += two; // error: two
    n->x = 3; // error: pointer
    return three; // error: three
}
