/* A parenthesis that is never closed. */
int main(void)
{
    int n = (1 + 2; // error: expected ')' before ';'
    return n;
}
