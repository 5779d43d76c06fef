/* An else belongs to an if. */
int main(void)
{
    int n = 1;
    while (n)
        n--;
    else // error: 'else' without a previous 'if'
        n = 2;
    return n;
}
