/* A for has three parts. */
int main(void)
{
    for (int i = 0; i < 3) // error: expected ';' after '3'
        return i;
    return 0;
}
