/* Keywords are not names. */
int main(void)
{
    int while = 3; // error: expected a declaration before 'while'
    return 0;
}
