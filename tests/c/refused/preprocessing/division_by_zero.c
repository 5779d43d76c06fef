/* Conditions are computed while compiling. */
#if 5 / 0 // error: division by zero
#endif

int main(void)
{
    return 0;
}
