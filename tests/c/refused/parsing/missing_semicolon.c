/* A syntax error. */
int main(void)
{
    int i = 0 // error: expected ';'
    return i;
}
