/* break without a loop. */
int main(void)
{
    break; // error: break
    return 0;
}
