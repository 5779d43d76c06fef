/* A statement that is not one. */
int main(void)
{
    int n = 1;
    if n > 0 // error: expected '(' before 'n'
        n = 2;
    return n;
}
