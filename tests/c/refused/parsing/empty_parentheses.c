/* A condition must be there. */
int main(void)
{
    while () // error: expected an expression before ')'
        return 1;
    return 0;
}
