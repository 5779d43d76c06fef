/* Something is missing behind an operator. */
int main(void)
{
    int n = 3 * ; // error: expected an expression before ';'
    return n;
}
